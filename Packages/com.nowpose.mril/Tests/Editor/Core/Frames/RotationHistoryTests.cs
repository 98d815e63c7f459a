using Nowpose.Frames;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    public class RotationHistoryTests
    {
        const double Interval = 0.05;
        const int Samples = 200, Capacity = 128;

        readonly RotationHistory _history = new RotationHistory();
        readonly Vector3D[] _angles = new Vector3D[Samples];

        [SetUp]
        public void Fill() => Fill(Samples);

        void Fill(int samples)
        {
            _history.Clear();
            for (var k = 0; k < samples; k++) _angles[k] = _history.Add(k * Interval, Truth(k));
        }

        [Test]
        public void RotationOf_AnyKeptSample_IsItsRotation() => AssertAllExcept(-1);

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(60)]
        [TestCase(127)]
        public void Remove_AnyAge_KeepsTheOtherRotations(int age)
        {
            _history.Remove((Samples - 1 - age) * Interval);

            Assert.That(_history.Count, Is.EqualTo(Capacity - 1));
            Assert.That(_history.Newest, Is.EqualTo(Truth(age == 0 ? Samples - 2 : Samples - 1)));
            AssertAllExcept(age);
        }

        [Test]
        public void Remove_UnknownTime_ChangesNothing()
        {
            _history.Remove((Samples - 0.5) * Interval);

            Assert.That(_history.Count, Is.EqualTo(Capacity));
            AssertAllExcept(-1);
        }

        [Test]
        public void Add_OlderThanAllKeptSamples_ChangesNothing()
        {
            _history.Add(-Interval, Truth(-1));

            AssertAllExcept(-1);
        }

        // Stamps that were converted to seconds may differ by a rounding error.
        [TestCase(49, 1e-8)]
        [TestCase(49, -1e-8)]
        [TestCase(20, 1e-8)]
        [TestCase(20, -1e-8)]
        [TestCase(0, -1e-8)]
        public void Add_RepeatedSample_ReturnsTheSameAngles(int k, double rounding)
        {
            Fill(50);

            var angles = _history.Add(k * Interval + rounding, Truth(k));

            Assert.That(angles, Is.EqualTo(_angles[k]));
            Assert.That(_history.Count, Is.EqualTo(50));
        }

        void AssertAllExcept(int removed)
        {
            for (var age = 0; age < Capacity; age++)
            {
                if (age == removed) continue;
                var k = Samples - 1 - age;
                var error = _history.RotationOf(_angles[k], k * Interval) * Truth(k).Inverse;
                Assert.That(error.Log().Length, Is.LessThan(1e-12), $"sample {k}");
            }
        }

        static UnitQuaternion Truth(int k) => BodyMotions.HandHeld(k * Interval).Rotation;
    }
}
