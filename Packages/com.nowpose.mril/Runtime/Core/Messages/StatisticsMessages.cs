namespace Nowpose.Messages
{
    /// <summary>Error messages about invalid calls of the statistics functions.</summary>
    static class StatisticsMessages
    {
        public const string WindowSize = "window must be 1 or more";
        public const string Empty = "no duration has been added yet; check Count first";
        public const string Fraction = "fraction must be 0 to 1";
    }
}
