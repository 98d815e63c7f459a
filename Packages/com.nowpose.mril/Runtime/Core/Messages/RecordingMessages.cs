namespace Nowpose.Messages
{
    /// <summary>Error messages about recordings.</summary>
    static class RecordingMessages
    {
        public static string MaxSize(string path, string megabytes) =>
            $"recording {path} has stopped: it has reached its maximum size of {megabytes} MB; start a new recording or increase the maximum";

        public static string Stopped(string path, string reason) => $"recording {path} has stopped: {reason}";

        public const string NoPath = "recording: no file is given; enter a path";
    }
}
