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
    }
}
