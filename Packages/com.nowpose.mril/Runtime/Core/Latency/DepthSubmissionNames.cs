namespace Nowpose.Latency
{
    /// <summary>Names of depth submission states in files.</summary>
    static class DepthSubmissionNames
    {
        static readonly string[] Names = { "unknown", "active", "turned_off", "not_supported", "no_main_camera", "not_requested" };

        public static string NameOf(DepthSubmission depth) => Names[(int)depth];
    }
}
