using System;

namespace Nowpose.Editor.Setup
{
    /// <summary>Checks one requirement of a project for a headset.</summary>
    sealed class ProjectCheck
    {
        readonly Func<IProjectSettings, CheckResult> _look;
        readonly Func<IProjectSettings, string> _fix;

        /// <summary>Creates a check whose fix may need the user, or a check without a fix.</summary>
        /// <param name="title">The requirement in a few words.</param>
        /// <param name="why">Purpose of the requirement, and the consequence if it is not met.</param>
        /// <param name="look">Checks the project. Does not change it.</param>
        /// <param name="fixLabel">Label of the button that calls <see cref="Fix"/>; null if only the user can make the change.</param>
        /// <param name="fix">Changes the project. Returns null if the change succeeded; otherwise an instruction for the user.</param>
        public ProjectCheck(
            string title, string why, Func<IProjectSettings, CheckResult> look, string fixLabel = null, Func<IProjectSettings, string> fix = null)
        {
            Title = title;
            Why = why;
            FixLabel = fixLabel;
            _look = look;
            _fix = fix;
        }

        public string Title { get; }

        /// <summary>Purpose of the requirement, and the consequence if it is not met.</summary>
        public string Why { get; }

        /// <summary>Label of the button that calls <see cref="Fix"/>; null if only the user can make the change.</summary>
        public string FixLabel { get; }

        /// <summary>Checks the project. Does not change it.</summary>
        public CheckResult Look(IProjectSettings project) => _look(project);

        /// <summary>Returns a fix that always succeeds.</summary>
        /// <remarks>
        /// A second constructor would be ambiguous: an assignment of a text is also a function that returns the text, which would then be an instruction.
        /// </remarks>
        public static Func<IProjectSettings, string> Always(Action<IProjectSettings> fix) => project =>
        {
            fix(project);
            return null;
        };

        /// <summary>Changes the project to meet the requirement. Called only when the user clicks the button.</summary>
        /// <returns>Null if the change succeeded; otherwise an instruction for the user.</returns>
        public string Fix(IProjectSettings project) => _fix?.Invoke(project);
    }
}
