using Nowpose.Latency;

namespace Nowpose.Messages
{
    /// <summary>Messages about problems with depth submission.</summary>
    static class DepthSubmissionMessages
    {
        /// <summary>Returns the problem and its remedy in one line. Allocates nothing.</summary>
        /// <returns>Null when depth is submitted or the state is unknown.</returns>
        public static string ProblemOf(DepthSubmission depth)
        {
            switch (depth)
            {
                case DepthSubmission.TurnedOff:
                    return "depth is not submitted: it is turned off; set Depth Submission Mode to 16 or 24 bit in Project Settings, XR Plug-in "
                        + "Management, OpenXR";
                case DepthSubmission.NotSupported:
                    return "depth is not submitted: the runtime has not enabled XR_KHR_composition_layer_depth; set Depth Submission Mode before "
                        + "the app starts, and update the runtime";
                case DepthSubmission.NoMainCamera:
                    return "depth is not submitted: no enabled camera has the tag MainCamera; tag the headset's camera";
                case DepthSubmission.NotRequested:
                    return "depth might not be submitted: the display does not ask Unity to fill its depth buffer; check the OpenXR plugin's log "
                        + "and the render pipeline's depth settings";
                default: return null;
            }
        }
    }
}
