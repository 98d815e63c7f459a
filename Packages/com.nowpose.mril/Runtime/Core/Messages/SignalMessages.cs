namespace Nowpose.Messages
{
    /// <summary>Reasons why the value of a signal is not current.</summary>
    static class SignalMessages
    {
        public const string OlderThanConnection = "no value since the connection was restored";
    }
}
