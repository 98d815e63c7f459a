namespace Nowpose
{
    static class ClockStateWord
    {
        /// <summary>Returns the spelling in the protocol, pages, logs and command lines.</summary>
        public static string Word(this ClockState state) => state.ToString().ToLowerInvariant();
    }
}
