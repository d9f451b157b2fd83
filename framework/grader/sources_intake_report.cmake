# Scores, intake, reports and the text helpers of the grader; paths relative to framework/grader.
set(MUELLE_GRADER_INTAKE_REPORT_SOURCES
  verdict.cpp
  intake/archive.cpp
  intake/collector.cpp
  intake/folder.cpp
  intake/intake.cpp
  intake/read_file.cpp
  report/explanation.cpp
  report/format.cpp
  report/html_page.cpp
  report/junit_xml.cpp
  report/results_json.cpp
  report/terminal_table.cpp
  report/write_reports.cpp
  text/escape.cpp
  text/printable.cpp
  text/utf8.cpp)
