using System;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol.Cell;
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
            var cell = new VirtualCell(new CellMotion(work), clock, VirtualCellRun.Settings(), seed: 1, start);
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

        [Test]
        public void Messages_AfterAPause_HaveOnlyTheValuesThatDiffer()
        {
            var robot = UrdfFiles.Robot("youbot");
            var work = new CellWork(robot, new PickAndPlaceMotion(robot));
            var messages = new WorkMessages(work);
            ControlTime At(double seconds) => ControlTime.FromSeconds(1000 + seconds);
            SignalsMessage[] Until(double seconds) => messages.ChangesUntil(At(seconds), seconds).ToArray();
            Until(10);
            messages.Skip();
            var end = 600.0;
            while (ValueAt(work, end) == ValueAt(work, 10)) end += 0.1;

            var sent = Until(end);

            Assert.That(sent.Select(message => message.Stamp), Is.EqualTo(new[] { At(end) }));
            Assert.That(Until(end + work.CycleSeconds), Is.Not.Empty, "changes after the pause");
        }

        static double ValueAt(CellWork work, double seconds)
        {
            var values = new double[work.Signals.Count];
            work.SignalsAt(seconds, values);
            return values[0];
        }

        static CompensationSession NewSession() => new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)), new PredictionSettings(Predictors.Default)),
            UrdfFiles.Robot("youbot"), new StopwatchHeadsetClock());
    }
}
