namespace Nowpose.Editor.Setup
{
    /// <summary>Result of a check.</summary>
    readonly struct CheckResult
    {
        public CheckResult(CheckState state, string found)
        {
            State = state;
            Found = found;
        }

        public CheckState State { get; }

        /// <summary>Description of the value that the check has found.</summary>
        public string Found { get; }

        public static CheckResult Good(string found) => new CheckResult(CheckState.Good, found);

        public static CheckResult Missing(string found) => new CheckResult(CheckState.Missing, found);

        public static CheckResult Advice(string found) => new CheckResult(CheckState.Advice, found);

        public static CheckResult Unknown(string found) => new CheckResult(CheckState.Unknown, found);
    }
}
