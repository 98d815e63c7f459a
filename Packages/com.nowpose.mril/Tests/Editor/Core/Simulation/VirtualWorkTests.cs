using System;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Simulation.Work;
using Nowpose.Tests.Core.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    /// <summary>Tests the signals of a virtual cell that serves one session after another, as after a pause of the headset.</summary>
    public class VirtualWorkTests
    {
        [Test]
        public void Run_NewSession_ReceivesTheValueOfEachSignalWithItsStamp()
        {
            var start = HeadsetTime.FromSeconds(500);
            var robot = UrdfFiles.Robot("youbot");
            var work = new CellWork(robot, new PickAndPlaceMotion(robot));
            var clock = new VirtualClock(start, TimeSpan.FromSeconds(1000), 0);
            var cell = new VirtualCell(work, clock, VirtualCellRun.Settings(), seed: 1, start);
            var sessions = new[] { NewSession(), NewSession() };
            var now = start;
            void Run(CompensationSession session, double seconds)
            {
                for (var end = now + ClockTicks.Span(seconds); now < end; now += ClockTicks.Span(1 / 60.0))
                {
                    cell.Run(now, session);
                    session.Tick(now);
                }
            }

            Run(sessions[0], 10);
            var signals = sessions[0].Signals.Table;
            // The clock of the new session is known after a few sync exchanges.
            Run(sessions[1], 1);

            foreach (var name in work.Signals)
            {
                var signal = sessions[1].Signals.Table.Find(name);
                Assert.That(signal?.IsKnown, Is.True, name);
                Assert.That(signal.Since >= signals.Find(name).Since, Is.True, name);
            }
        }

        static CompensationSession NewSession() => new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)), new PredictionSettings(Predictors.Default)),
            UrdfFiles.Robot("youbot"), new StopwatchHeadsetClock());
    }
}
