using System.Collections.Generic;
using Nowpose.Editor.Messages;
using Nowpose.Latency;
using Nowpose.Session;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Creates the rows, each with a label and a value, for those statistics of a session that the status panel does not show.</summary>
    static class SessionRows
    {
        public static IEnumerable<(string Label, string Value)> Of(SessionStatistics session)
        {
            yield return ("Round trip", LiveText.Ms(session.RoundTripTime));
            yield return ("Clock steps", session.ClockSteps.ToString());
            yield return (InspectorTexts.EndToEnd, LiveText.Ms(session.EndToEndLatency));
            yield return ("Display time", DisplayTimeOf(session));
            yield return ("Reprojection, depth", Words(LatencyNames.Reprojection.NameOf(session.Reprojection)) + ", "
                + Words(LatencyNames.DepthSubmission.NameOf(session.DepthSubmission)));
            yield return ("Error, uncompensated", LiveText.Mm(session.ErrorMm) + ", " + LiveText.Mm(session.HoldErrorMm));
            yield return ("Pose current, last 10 s", LiveText.Number(100 * session.CurrentShare, "0", " %"));
            foreach (var joint in session.JointStatuses) yield return ("Joint " + joint.Joint, joint.Description);
            yield return ("Samples, dropped", session.Samples + ", " + session.Dropped);
            yield return ("Clock sync", session.SyncLink.Detail);
            yield return ("Joint positions", session.SampleLink.Detail);
        }

        static string Words(string name) => name.Replace('_', ' ');

        static string DisplayTimeOf(SessionStatistics session)
        {
            if (session.IsDisplayTimeImplausible) return "implausible, " + LiveText.Ms(session.DisplayTimeAhead) + " ahead";
            return session.IsLightPredicted ? InspectorTexts.Predicted : "as calibrated";
        }
    }
}
