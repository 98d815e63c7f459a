namespace Nowpose.Editor.Setup
{
    /// <summary>One point in which a project can be ready for the headset or not. Looking changes nothing.</summary>
    abstract class ProjectCheck
    {
        /// <param name="fixLabel">Null where only the user can do it.</param>
        protected ProjectCheck(string title, string why, string fixLabel)
        {
            Title = title;
            Why = why;
            FixLabel = fixLabel;
        }

        public string Title { get; }

        /// <summary>What it is good for, and what happens without.</summary>
        public string Why { get; }

        /// <summary>What the button says; null where only the user can do it.</summary>
        public string FixLabel { get; }

        public abstract CheckResult Look(IProjectSettings project);

        /// <summary>Does what is missing. Called for a click only.</summary>
        /// <returns>What the user has to do where it could not be done; null where it was.</returns>
        public abstract string Fix(IProjectSettings project);

        protected static CheckResult Good(string found) => new CheckResult(CheckState.Good, found);

        protected static CheckResult Missing(string found) => new CheckResult(CheckState.Missing, found);
    }
}
