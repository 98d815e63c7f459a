using System.Collections.Generic;
using System.Linq;

namespace Nowpose.Editor.Setup
{
    /// <summary>Runs checks and stores their newest results. Changes the project only in <see cref="Fix"/>.</summary>
    sealed class ProjectReview
    {
        readonly IReadOnlyList<ProjectCheck> _checks;
        readonly IProjectSettings _project;
        readonly CheckResult[] _results;
        readonly string[] _advice;

        /// <param name="advice">Value of <see cref="Advice"/> of an earlier review with the same checks; null or empty if there was none.</param>
        public ProjectReview(IReadOnlyList<ProjectCheck> checks, IProjectSettings project, IReadOnlyList<string> advice = null)
        {
            _checks = checks;
            _project = project;
            _results = new CheckResult[checks.Count];
            _advice = new string[checks.Count];
            // Unity serialises null as an empty string.
            if (advice?.Count == checks.Count) _advice = advice.Select(text => string.IsNullOrEmpty(text) ? null : text).ToArray();
            Refresh();
        }

        public IReadOnlyList<ProjectCheck> Checks => _checks;

        /// <summary>Newest result of each check.</summary>
        public IReadOnlyList<CheckResult> Results => _results;

        /// <summary>For each check, the instruction for the user from its last <see cref="Fix"/>; null if there is none.</summary>
        public IReadOnlyList<string> Advice => _advice;

        public int MissingCount => _results.Count(r => r.State == CheckState.Missing);

        public void Refresh()
        {
            for (var i = 0; i < _checks.Count; i++)
            {
                _results[i] = _checks[i].Look(_project);
                if (_results[i].State == CheckState.Good) _advice[i] = null;
            }
        }

        public void Fix(int check)
        {
            _advice[check] = _checks[check].Fix(_project);
            Refresh();
        }
    }
}
