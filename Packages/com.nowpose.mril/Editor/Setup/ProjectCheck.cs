namespace Nowpose.Editor.Setup
{
    /// <summary>One requirement of a project for a headset. <see cref="Look"/> changes nothing.</summary>
    abstract class ProjectCheck
    {
        /// <param name="fixLabel">Label of the button; null if only the user can make the change.</param>
        protected ProjectCheck(string title, string why, string fixLabel)
        {
            Title = title;
            Why = why;
            FixLabel = fixLabel;
        }

        public string Title { get; }

        /// <summary>Purpose of the requirement, and the consequence of not meeting it.</summary>
        public string Why { get; }

        /// <summary>Label of the button; null if only the user can make the change.</summary>
        public string FixLabel { get; }

        public abstract CheckResult Look(IProjectSettings project);

        /// <summary>Changes the project to meet the requirement. Called only for a click.</summary>
        /// <returns>What the user has to do if the change failed; null if it succeeded.</returns>
        public abstract string Fix(IProjectSettings project);

        protected static CheckResult Good(string found) => new CheckResult(CheckState.Good, found);

        protected static CheckResult Missing(string found) => new CheckResult(CheckState.Missing, found);
    }
}
