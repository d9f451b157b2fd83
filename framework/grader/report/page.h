#pragma once
/// \file
/// What every page of the grader is made of.

#include <string>
#include <vector>

namespace muelle::grader {

/// A whole HTML page around `body`: nothing else is loaded and nothing runs, by a Content-Security-Policy that allows
/// only inline styles and images inside the page. The title is escaped here; `body` must be by whom it is made. `style`
/// is added to the style sheet that all pages have (page_style.h).
std::string page(const std::string& title, const std::string& body, const std::string& style = "");

/// The class of an element that shows points: "passed" for full marks, "part", "failed" for none.
std::string classOf(double points, double most);

/// A bar that is filled to points / most.
std::string bar(double points, double most);

/// The text, escaped, in a <p> of that class; "" when there is none.
std::string paragraph(const char* kind, const std::string& text);

/// What stands below a page: the sandbox, and notes under their heading where there are any. All are escaped here.
std::string pageFooter(const std::string& sandbox, const std::string& heading, const std::vector<std::string>& notes);

/// A path below the page's folder as a relative link: every byte that means something in an address, in UTF-8 and
/// outside, is percent-encoded; "/" stays.
std::string relativeLink(const std::string& path);

}  // namespace muelle::grader
