using System.Collections.Generic;
using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Unity;

namespace Nowpose.Editor
{
    /// <summary>How a session does, as lines of a label and a value.</summary>
    static class SessionRows
    {
        public static IEnumerable<(string Label, string Value)> Of(SessionStatistics session)
        {
            yield return ("Pose", session.Pose.ToString());
            yield return ("Clock", Clock(session));
            yield return ("Round trip", LiveText.Ms(session.RoundTripTime));
            yield return ("L_app, median (95 %)", LiveText.Ms(session.ApplicationLatency) + " (" + LiveText.Ms(session.ApplicationLatency95) + ")");
            yield return ("L_visu", LiveText.Ms(session.VisualisationLatency));
            yield return ("End to end", LiveText.Ms(session.EndToEndLatency));
            yield return ("Horizon", LiveText.Ms(session.Horizon));
            yield return ("Render time", LiveText.Ms(session.RenderTime) + ", " + RenderTimeWords.NameOf(session.RenderTimeSource));
            yield return ("Constant-latency range", Range(session));
            yield return ("Error (uncompensated)", LiveText.Mm(session.ErrorMm) + " (" + LiveText.Mm(session.HoldErrorMm) + ")");
            yield return ("Error reduction", LiveText.Percent(session.ErrorReduction));
            yield return ("Samples (dropped)", session.Samples + " (" + session.Dropped + ")");
            yield return ("Robot description", session.RobotDescriptionMatch.ToString());
            yield return ("Clock connection", session.SyncLink.Detail);
            yield return ("Sample connection", session.SampleLink.Detail);
            yield return ("Security", session.Security.ToString());
        }

        static string Clock(SessionStatistics session) => session.Clock.IsKnown
            ? session.Clock.State + ", ± " + LiveText.Ms(session.Clock.ErrorBound) + Steps(session.ClockSteps)
            : session.Clock.State.ToString();

        static string Steps(int steps) => steps == 0 ? "" : ", " + steps + (steps == 1 ? " step" : " steps");

        static string Range(SessionStatistics session) =>
            session.Range == RangeState.Unknown ? LiveText.Unknown + " (" + session.RangeDoubt + ")" : session.Range.ToString();
    }
}
