namespace Nowpose.Editor.Setup
{
    /// <summary>Checks one requirement of a project for a headset.</summary>
    abstract class ProjectCheck
    {
        /// <param name="title">The requirement in a few words.</param>
        /// <param name="why">Purpose of the requirement, and the consequence if it is not met.</param>
        /// <param name="fixLabel">Label of the button that calls <see cref="Fix"/>; null if only the user can make the change.</param>
        protected ProjectCheck(string title, string why, string fixLabel)
        {
            Title = title;
            Why = why;
            FixLabel = fixLabel;
        }

        public string Title { get; }

        /// <summary>Purpose of the requirement, and the consequence if it is not met.</summary>
        public string Why { get; }

        /// <summary>Label of the button that calls <see cref="Fix"/>; null if only the user can make the change.</summary>
        public string FixLabel { get; }

        /// <summary>Checks the project. Does not change it.</summary>
        public abstract CheckResult Look(IProjectSettings project);

        /// <summary>Changes the project to meet the requirement. Called only when the user clicks the button.</summary>
        /// <returns>Null if the change succeeded; otherwise an instruction for the user.</returns>
        public abstract string Fix(IProjectSettings project);

        protected static CheckResult Good(string found) => new CheckResult(CheckState.Good, found);

        protected static CheckResult Missing(string found) => new CheckResult(CheckState.Missing, found);
    }
}
