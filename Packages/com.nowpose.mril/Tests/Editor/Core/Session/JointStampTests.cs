using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Session.Cell;
using Nowpose.Simulation;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.WatchedSession;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests joints whose source has another clock, or whose only sample is from before a restart of the clock.</summary>
    public class JointStampTests
    {
        static SimulatedSession Running(double stampErrorSeconds, string predictor = "quadratic")
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed, predictor) { StampErrorSeconds = stampErrorSeconds };
            simulated.Session.Listener.Connected(HeadsetTime.FromSeconds(0));
            simulated.Run(10);
            return simulated;
        }

        static void Receive(SimulatedSession simulated, string joint, double age)
        {
            var message = new JointStateMessage(ControlNow(simulated) - Lengths.Seconds(age), new[] { joint }, new[] { 0.03 });
            simulated.Session.Listener.Received(message, HeadsetTime.FromSeconds(simulated.Now));
        }

        [Test]
        public void Horizon_GripperStampsAhead_IsThatOfTheArm()
        {
            var simulated = Running(0);

            Receive(simulated, "grip", age: -0.9);
            simulated.Run(0.1);

            Assert.That(StatisticsOf(simulated).Horizon.Value.TotalSeconds, Is.InRange(0.05, 0.25));
        }
    }
}
