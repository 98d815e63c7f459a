using System.Linq;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using NUnit.Framework;

namespace Nowpose.Tests.Unity
{
    public class PoseLookTests
    {
        [Test]
        public void Of_Current_IsDrawnUnchanged()
        {
            var look = PoseLook.Of(PoseState.Current);

            Assert.That(look.IsDrawn, Is.True);
            Assert.That(look.Fade, Is.EqualTo(0));
            Assert.That(look.IsHatched, Is.False);
            Assert.That(look.Label, Is.Empty);
        }

        [Test]
        public void Of_NotCurrent_IsFaintStripedAndHasText()
        {
            var states = new[] { PoseState.Incomplete, PoseState.Unsynchronised, PoseState.Held, PoseState.OutsideRange };
            foreach (var state in states)
            {
                var look = PoseLook.Of(state);

                Assert.That(look.Fade, Is.GreaterThan(0.2), state.ToString());
                Assert.That(look.IsHatched, Is.True, state.ToString());
                Assert.That(look.Label, Is.Not.Empty, state.ToString());
            }
            Assert.That(states.Select(s => PoseLook.Of(s).Label), Is.Unique);
        }

        [TestCase(OutsideRangeResponse.Fade, 0.3f)]
        [TestCase(OutsideRangeResponse.GoOn, 0.2f)]
        [TestCase(OutsideRangeResponse.Hold, 0.5f)]
        public void Of_OutsideRange_IsStripedAndHasTextForAnyFade(OutsideRangeResponse response, float fade)
        {
            var look = PoseLook.Of(PoseState.OutsideRange, response);

            Assert.That(look.Fade, Is.EqualTo(fade));
            Assert.That(look.IsDrawn, Is.True);
            Assert.That(look.IsHatched, Is.True);
            Assert.That(look.Label, Does.Contain(PoseMessages.Of(PoseState.OutsideRange)));
        }

        [Test]
        public void Also_ZeroFade_StillFadesThePart()
        {
            var look = PoseLook.Of(PoseState.Current).Also("being placed", "a marker is moved", 0);

            Assert.That(look.IsHatched, Is.True);
            Assert.That(look.Fade, Is.EqualTo(0.2f), "a part smaller than a stripe may have no stripe");
        }

        [Test]
        public void Of_Incomplete_IsNotDrawn()
        {
            Assert.That(PoseLook.Of(PoseState.Incomplete).IsDrawn, Is.False);
        }

        [Test]
        public void NoSession_AnyPart_IsDrawnAsNotCurrent()
        {
            Assert.That(PoseLook.NoSession.IsDrawn, Is.True);
            Assert.That(PoseLook.NoSession.IsHatched, Is.True);
            Assert.That(PoseLook.NoSession.Label, Is.Not.Empty);
        }
    }
}
