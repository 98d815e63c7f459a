namespace Nowpose.Unity.Messages
{
    /// <summary>Error messages about latency profiles on the device.</summary>
    static class LoaderMessages
    {
        public static string InArchive(string path) =>
            "latency profile: on this device, StreamingAssets is inside the app's archive, where no file can be opened; assign the profile as a "
            + $"text asset, or copy it to {path}";

        public const string Unkept = "an unsaved calibration";
    }
}
