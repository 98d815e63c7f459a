using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests grips by reach whose data are late or missing: the signal, the joints, or the poses of objects.</summary>
    public class GripDataTests
    {
        [TestCase("adaptive", 0.01)]
        [TestCase("adaptive", 0.025)]
        [TestCase("adaptive", 0.05)]
        [TestCase("linear", 0.05)]
        [TestCase("quadratic", 0.05)]
        public void Close_PosesOfAnotherObjectHaveStopped_HoldsTheObject(string predictor, double interval)
        {
            var cell = new CellSession(predictor: predictor);
            var grip = NewGrip(cell, "box", "far");
            cell.Sampling = t =>
            {
                SendShoulder(cell, t, interval);
                cell.Send("world", "box", t, At(1, 0.02));
                if (t < Close - 1) cell.Send("world", "far", t, At(5, 0));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 0.1);

            Until(cell, Close + 2, t => Assert.That((grip.Held, grip.Fault, StateOf(cell)),
                Is.EqualTo(("box", (string)null, PoseState.Current)), $"{t} s"));
        }

        // The displayed place in the hand must not wait for the object whose poses have stopped.
        [Test]
        public void Close_PosesOfAnotherObjectHaveStopped_IsCorrectedWhenTheSamplesArrive()
        {
            var (cell, grip) = NewCell("box", "far");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(Math.Min(t, Close)), 0);
                cell.Send("world", "box", t, At(1, 0));
                if (t < Close - 1) cell.Send("world", "far", t, At(5, 0));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close - 0.3);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 0.5);

            Assert.That(grip.Held, Is.EqualTo("box"));
            Assert.That(Distance(ToolOf(cell).Inverse * Find(cell, "box").World, RigidTransform.Identity), Is.LessThan(1e-6));
        }

        // For example, the gripper covers the object's marker. The predictions at the closing are wrong, because the arm and the object stop before.
        [TestCase(0, Close + 0.5)]
        [TestCase(0.3, Close + 1.5)]
        public void Close_PosesOfTheObjectStopAtTheClosing_IsCorrectedByTheSamplesFromBefore(double boxDelay, double corrected)
        {
            const double stop = Close - 0.1, speed = 0.2;
            RigidTransform Box(double t) => At(1 + speed * (Math.Min(t, stop) - stop), 0.02);
            RigidTransform Arm(double t) => Tool(Shoulder(Math.Min(t, stop)));
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t < Close + 1 ? Math.Min(t, stop) : t), 0);
                if (t - boxDelay < Close - 0.01) cell.Send("world", "box", t - boxDelay, Box(t - boxDelay));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close - 0.3);
            cell.Send("grip", Close, 1);
            Until(cell, corrected);

            Assert.That(grip.Held, Is.EqualTo("box"));
            Assert.That(Distance(Find(cell, "box").Held, Arm(Close).Inverse * Box(Close)), Is.LessThan(1e-6));

            Until(cell, Open);
            cell.Send("grip", Open, 0);
            Until(cell, Open + 0.5);
            Assert.That(Distance(Find(cell, "box").World, Tool(Shoulder(Open)) * Arm(Close).Inverse * Box(Close)), Is.LessThan(1e-3));
        }

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

        [Test]
        public void Open_ArmHasNoData_ObjectIsNotCurrentAndFollowsItsSource()
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                if (t < Open - 1.5 || t > Open + 2) cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(1, 0.02));
            };
            CloseAndOpen(cell);
            Until(cell, Open + 0.1);

            Until(cell, Open + 4, t => Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held), $"{t} s"));

            Assert.That(grip.Held, Is.Null);
            Assert.That(Find(cell, "box").GripFault, Is.EqualTo(FrameMessages.ReleasedUnnoticed));
            Assert.That(cell.Session.Frames.HeldSince(Find(cell, "box")), Is.EqualTo((ControlTime?)ControlTime.FromSeconds(Open)));
            Assert.That(Distance(Find(cell, "box").World, At(1, 0.02)), Is.LessThan(1e-9));
        }

        // The gap is too long for an interpolation, and the joints are current again before the release is final.
        [Test]
        public void Open_InAGapOfTheJoints_ObjectIsNeverCurrent()
        {
            var (cell, _) = NewCell("box");
            cell.Sampling = t =>
            {
                if (Math.Abs(t - Open) > 0.35) cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(1, 0.02));
            };
            CloseAndOpen(cell);
            Until(cell, Open + 0.1);

            Until(cell, Open + 3, t => Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held), $"{t} s"));

            Assert.That(cell.Session.Robots[0].Frame.State, Is.EqualTo(PoseState.Current));
        }

        // The source of the object repeats the place from before the grip.
        [TestCase(false, 0)]
        [TestCase(false, 0.001)]
        [TestCase(true, 0)]
        public void Close_SourceOfAnObjectStartsAfterwards_ObjectIsHeldUntilItsSourceReportsAnotherPose(bool isStationary, double noise)
        {
            var random = new Random(1);
            var (cell, grip) = NewCell("box", "far");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "far", t, At(5, 0));
                if (t <= 25 || isStationary && t >= 25.1) return;
                cell.Send("world", "box", t, At((t < 28 ? 1 : 1.1) + noise * random.NextNormal(), 0.02), isStationary);
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, 25);
            Assert.That((grip.Held, grip.Fault, StateOf(cell, "far")), Is.EqualTo(((string)null, (string)null, PoseState.Current)));
            Until(cell, 25.5);

            Until(cell, 26, t => Assert.That((grip.Fault, StateOf(cell), StateOf(cell, "far")),
                Is.EqualTo((FrameMessages.ObjectWithoutPose, PoseState.Held, PoseState.Current)), $"{t} s"));

            cell.Send("grip", 26, 0);
            Until(cell, 27);
            Assert.That((grip.Fault, StateOf(cell), StateOf(cell, "far")), Is.EqualTo(((string)null, PoseState.Held, PoseState.Current)));

            Until(cell, 29);
            if (isStationary) cell.Send("world", "box", 29, At(1.1, 0.02), isStationary: true);
            Until(cell, 30);
            Assert.That(StateOf(cell), Is.EqualTo(PoseState.Current));
        }

        // A gripper that holds an object cannot hold another one.
        [Test]
        public void Close_SourceOfAnotherObjectStartsDuringTheGrip_IsCurrent()
        {
            var (cell, grip) = NewCell("box", "next");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(1, 0.02));
                if (t > Close + 0.5) cell.Send("world", "next", t, At(1, 0.02));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 1.5);

            Assert.That((grip.Held, grip.Fault, StateOf(cell, "next")), Is.EqualTo(("box", (string)null, PoseState.Current)));
        }

        // The base of a mobile robot may have moved on since its newest pose.
        [Test]
        public void Open_PosesOfTheBaseHaveStopped_ObjectIsNotCurrent()
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                if (t < Open - 1) cell.Send("world", "base", t, At(0.2 * (t - Close), 0));
                cell.Send("world", "box", t, At(1, 0.02));
            };
            CloseAndOpen(cell);
            Until(cell, Open + 0.1);

            Until(cell, Open + 3, t => Assert.That(StateOf(cell), Is.EqualTo(PoseState.Held), $"{t} s"));

            Assert.That(grip.Held, Is.Null);
        }

        [TestCase("base", FrameMessages.ArmWithoutData)]
        [TestCase("tray", FrameMessages.ObjectWithoutPose)]
        public void Close_PosesOfTheBaseOrParentHaveStopped_HeldObjectIsUnknown(string stopped, string fault)
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, 0, 0);
                foreach (var frame in new[] { "base", "tray" })
                    if (frame != stopped || Math.Abs(t - Close) > 1) cell.Send("world", frame, t, At(t < Close ? 0 : 0.5, 0));
                cell.Send("tray", "box", t, At(1, 0.02));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 3);

            Assert.That((grip.Held, grip.Fault, StateOf(cell)), Is.EqualTo(((string)null, fault, PoseState.Held)));
        }

        // The decision remains open for the object whose poses have stopped.
        [Test]
        public void Close_ComponentOfTheObjectIsDisabledForASecond_HoldsTheObject()
        {
            var cell = new CellSession();
            var objects = new List<string> { "box", "far" };
            var grip = NewGrip(cell, objects);
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, At(1, 0.02));
                if (t < Close - 0.3) cell.Send("world", "far", t, At(5, 0));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Close + 0.1);
            Assert.That(grip.Held, Is.EqualTo("box"));

            objects.Remove("box");
            Until(cell, Close + 1.3);
            objects.Add("box");
            Until(cell, Close + 2);

            Assert.That((grip.Held, StateOf(cell)), Is.EqualTo(("box", PoseState.Current)));
        }

        static void CloseAndOpen(CellSession cell)
        {
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Open);
            cell.Send("grip", Open, 0);
        }
    }
}
