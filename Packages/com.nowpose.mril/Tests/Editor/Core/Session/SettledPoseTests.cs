using System.Linq;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class SettledPoseTests
    {
        // Each letter stands for one frame of 0.1 s: . incomplete, u unsynchronised, h held, o outside range, c current.
        const string Letters = ".uhoc";

        [TestCase("cccc", "cccc", TestName = "Over_Current_IsCurrentFromTheFirstFrame")]
        [TestCase("..cc", "..cc", TestName = "Over_FirstPositions_AreShownAtOnce")]
        [TestCase(".uuhccccc", ".uuhccccc", TestName = "Over_CurrentForTheFirstTime_IsShownAtOnce")]
        [TestCase("cch", "cch", TestName = "Over_Worse_IsShownAtOnce")]
        [TestCase("chcccccccc", "chhhhhcccc", TestName = "Over_CurrentAgain_IsShownAfterHalfASecond")]
        [TestCase("chccchcchcccccc", "chhhhhhhhhhhhcc", TestName = "Over_Alternating_KeepsTheWorseState")]
        [TestCase("cohohohoooooo", "cohhhhhhhhhoo", TestName = "Over_AlternatingNotCurrent_KeepsTheWorseState")]
        [TestCase("chooccccccc", "chhhhhooccc", TestName = "Over_TwoReasons_EachLastsHalfASecond")]
        [TestCase("cuhoccccccc", "cuuuuuhoccc", TestName = "Over_Improving_ShowsTheWorstOfTheLastHalfSecond")]
        [TestCase("chc.ccccc", "chh.hhccc", TestName = "Over_Incomplete_IsShownOnlyWhileItLasts")]
        public void Over_Frames_ReturnsTheExpectedStates(string frames, string expected)
        {
            var settled = new SettledPose();

            var shown = frames.Select((letter, i) =>
            {
                var state = (PoseState)Letters.IndexOf(letter);
                settled.Add(HeadsetTime.FromSeconds(100 + i / 10.0), state);
                return Letters[(int)settled.Over(state)];
            });

            Assert.That(new string(shown.ToArray()), Is.EqualTo(expected));
        }

        // The joints are current, their moving base is not.
        [TestCase(true, PoseState.Held)]
        [TestCase(false, PoseState.Current)]
        public void Over_WorseStateAddedInAFrame_CountsAsTheStateOfTheFrame(bool wasCurrent, PoseState expected)
        {
            var settled = new SettledPose();
            if (wasCurrent) settled.Add(HeadsetTime.FromSeconds(99.9), PoseState.Current);
            settled.Add(HeadsetTime.FromSeconds(100), PoseState.Current);
            settled.Add(HeadsetTime.FromSeconds(100), PoseState.Held);
            Assert.That(settled.Over(PoseState.Held), Is.EqualTo(PoseState.Held));

            settled.Add(HeadsetTime.FromSeconds(100.1), PoseState.Current);

            Assert.That(settled.Over(PoseState.Current), Is.EqualTo(expected));
        }
    }
}
