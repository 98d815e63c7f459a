using System.Collections.Generic;
using System.Linq;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Session.Cell;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>A simulated session whose joints the gateway reports.</summary>
    static class WatchedSession
    {
        public const int Seed = 7;

        public static SimulatedSession Running(bool isEachJointApart = false)
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, Seed) { IsEachJointApart = isEachJointApart };
            simulated.Run(10);
            Assert.That(simulated.Session.Tick(HeadsetTime.FromSeconds(simulated.Now)).State, Is.EqualTo(PoseState.Current), "at the start, seed " + Seed);
            return simulated;
        }

        public static SessionStatistics StatisticsOf(SimulatedSession simulated) => simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));

        public static ControlTime ControlNow(SimulatedSession simulated)
        {
            var now = HeadsetTime.FromSeconds(simulated.Now);
            return simulated.Link.TrueOffset(now).ToControl(now);
        }

        public static void Report(SimulatedSession simulated, params JointReport[] joints) =>
            simulated.Session.Listener.StatusReceived(new JointStatusMessage(joints), HeadsetTime.FromSeconds(simulated.Now));

        public static void Report(SimulatedSession simulated, string joint, JointDataState state, double secondsAgo = 0, string reason = "") =>
            Report(simulated, new JointReport(joint, state, ControlNow(simulated) - Lengths.Seconds(secondsAgo), reason));

        public static Dictionary<string, string> DiagnosticsOf(SimulatedSession simulated) =>
            SessionDiagnostics.Of(StatisticsOf(simulated), CellFaults.None, "left", default).Values.ToDictionary(each => each.Key, each => each.Value);
    }
}
