using Nowpose.Anchoring;
using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    /// <summary>A base with three markers in view of a device that has spatial anchors.</summary>
    public abstract class AnchoredBaseFixture
    {
        private protected FakeAnchors _anchors;
        private protected SimulatedMarkers _cell;

        [SetUp]
        public void Begin()
        {
            _anchors = new FakeAnchors();
            _cell = SimulatedMarkers.Three(1);
            _cell.Anchors = _anchors;
        }

        private protected BaseTracker Tracker => _cell.Tracker;

        private protected void Lock() => Assert.That(_cell.RunUntilLocked(3), Is.Not.Null);

        private protected static RigidTransform Shift(double metres, double radians = 0) => RigidTransform.FromXyzRpy(metres, 0, 0, 0, 0, radians);
    }
}
