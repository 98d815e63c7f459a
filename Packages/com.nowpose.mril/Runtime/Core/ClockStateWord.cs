namespace Nowpose
{
    static class ClockStateWord
    {
        /// <summary>As protocol, pages, logs and command lines spell it.</summary>
        public static string Word(this ClockState state) => state.ToString().ToLowerInvariant();
    }
}
