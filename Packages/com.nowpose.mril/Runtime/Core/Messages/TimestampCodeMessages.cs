namespace Nowpose.Messages
{
    /// <summary>Error messages about invalid arguments for the code that shows the control time.</summary>
    static class TimestampCodeMessages
    {
        public const string TimeOutOfRange = "a coded time must be 0 to 65535 ms";

        public static string CellCount(int cells) => $"a code must have 64 cells, not {cells}";
    }
}
