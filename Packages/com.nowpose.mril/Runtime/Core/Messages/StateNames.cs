namespace Nowpose.Messages
{
    /// <summary>States of joints and figures in a few words.</summary>
    static class StateNames
    {
        public const string OtherSourceLimit = "limit of another source";
        public const string RenderTimeNotMeasured = "render time not measured";
        public const string ValuesUnusable = "values cannot be used";
    }
}
