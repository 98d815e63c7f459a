using System;
using Nowpose.Kinematics;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests grips by reach whose data are late or missing: the signal, the joints, or the poses of objects.</summary>
    public class GripDataTests
    {
        [TestCase("adaptive", 0.01)]
        [TestCase("adaptive", 0.025)]
        [TestCase("linear", 0.01)]
        [TestCase("quadratic", 0.05)]
        [TestCase("hold", 0.05)]
        public void CloseAndOpen_SignalArrivesLate_UsesThePosesAtItsStamps(string predictor, double interval)
        {
            const double late = 0.9, speed = 0.2;
            RigidTransform Box(double t) => At(1 + speed * (t - Close), 0.02);
            var cell = new CellSession(predictor: predictor);
            var grip = NewGrip(cell, "box");
            cell.Sampling = t =>
            {
                SendShoulder(cell, t, interval);
                for (var s = t; s > t - CellSession.Interval + 1e-9; s -= interval) cell.Send("world", "box", s, Box(Math.Min(s, Close + 1)));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close + late);
            SendGripNow(cell, Close, 1);
            Until(cell, Close + late + 0.5);

            Assert.That((grip.Held, grip.Fault), Is.EqualTo(("box", (string)null)));
            Assert.That(Distance(Find(cell, "box").Held, Tool(0).Inverse * Box(Close)), Is.LessThan(1e-3));

            const double open = Close + 2;
            Until(cell, open + late);
            SendGripNow(cell, open, 0);
            Until(cell, open + late + 0.5);
            Assert.That(Distance(Find(cell, "box").World, Tool(Shoulder(open)) * Tool(0).Inverse * Box(Close)), Is.LessThan(1e-3));
        }
    }
}
