using Nowpose.Protocol;
using Nowpose.Signals;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Signals
{
    /// <summary>Tests several values of a signal with the same time stamp.</summary>
    public class EqualStampTests
    {
        static ControlTime At(double seconds) => ControlTime.FromSeconds(seconds);

        // A gateway sends the value that arrived last when a headset connects, so all headsets must show this value.
        [Test]
        public void Add_AnotherValueWithTheSameStamp_TheLastOneIsShown([Values] bool isVisible, [Values] bool isRepeated)
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10), 1);
            if (isRepeated) signal.Add(At(10.5), 1);
            if (isVisible) signal.Next(At(10));

            Assert.That(signal.Add(At(10), 0), Is.EqualTo(DropReason.None));

            Assert.That((signal.Next(At(10.2)), signal.Value, signal.Since), Is.EqualTo((true, 0.0, (ControlTime?)At(10))));
            Assert.That(signal.Next(At(10.2)), Is.False);
            Assert.That((signal.Next(At(10.5)), signal.Value), Is.EqualTo((isRepeated, isRepeated ? 1.0 : 0.0)), "the repeated value is newer");
        }

        [Test]
        public void Add_ThirdValueWithTheSameStamp_IsShown([Values(0.5, 1)] double third)
        {
            var signal = new SignalTrack("grip");
            signal.Add(At(10), 1);
            signal.Next(At(10));
            signal.Add(At(10), 0);

            signal.Add(At(10), third);
            while (signal.Next(At(10))) { }

            Assert.That((signal.Value, signal.Since), Is.EqualTo((third, (ControlTime?)At(10))));
        }
    }
}
