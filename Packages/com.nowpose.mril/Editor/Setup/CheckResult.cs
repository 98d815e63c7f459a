namespace Nowpose.Editor.Setup
{
    /// <summary>What a check found.</summary>
    readonly struct CheckResult
    {
        public CheckResult(CheckState state, string found)
        {
            State = state;
            Found = found;
        }

        public CheckState State { get; }

        /// <summary>The value that was found, in words.</summary>
        public string Found { get; }
    }
}
