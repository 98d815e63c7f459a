using System;
using System.IO;
using System.Linq;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    public class StationaryFrameFileTests
    {
        string _folder, _path;

        [SetUp]
        public void Create()
        {
            _folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(_folder);
            _path = Path.Combine(_folder, "stationary-objects.json");
        }

        [TearDown]
        public void Remove() => Directory.Delete(_folder, true);

        static FrameTransform Frame(string child, double x, double yaw) =>
            RigidTransform.FromXyzRpy(x, -0.25, 1e-9, 0.1, -0.2, yaw).ToTransform(default, "world", child);

        [Test]
        public void Load_SavedFrames_RoundTripExactly()
        {
            var written = new[] { Frame("förderband \"1\"", 0.1, 3), Frame("fixture", -1 / 3.0, -3) };

            StationaryFrameFile.Save(_path, new TransformsMessage(written));
            StationaryFrameFile.Save(_path, StationaryFrameFile.Load(_path));
            var read = StationaryFrameFile.Load(_path);

            Assert.That(read.Count, Is.EqualTo(2));
            for (var i = 0; i < 2; i++)
            {
                Assert.That((read[i].Child, read[i].Parent, read[i].Stamp), Is.EqualTo((written[i].Child, "world", default(ControlTime))));
                Assert.That((read[i].X, read[i].Y, read[i].Z), Is.EqualTo((written[i].X, written[i].Y, written[i].Z)));
                Assert.That(read[i].Qw, Is.EqualTo(written[i].Qw).Within(1e-15));
                Assert.That(read[i].Qz, Is.EqualTo(written[i].Qz).Within(1e-15));
            }
        }

        static readonly object[][] InvalidContents =
        {
            new object[] { "\"w\": 1.0", "\"w\": 1.1", 25, FrameMessages.OfFrame("box", FrameMessages.Norm(1.1, "0.001")) },
            new object[]
            {
                "\"x\": 0.5", "\"x\": NaN", 14,
                FrameMessages.OfFrame("box", FrameMessages.WrongField("transform.translation.x", "NaN", FrameMessages.FiniteNumber)),
            },
            new object[]
            {
                "\"x\": 0.5", "\"x\": \"q\"", 14,
                FrameMessages.OfFrame("box", FrameMessages.WrongField("transform.translation.x", "\"q\"", FrameMessages.FiniteNumber)),
            },
            new object[]
            {
                "\"x\": 0.5", "\"x\": null", 14,
                FrameMessages.OfFrame("box", FrameMessages.WrongField("transform.translation.x", "null", FrameMessages.FiniteNumber)),
            },
            new object[]
            {
                "\"x\": 0.5", "\"x\": 2e6", 14,
                FrameMessages.OfFrame("box", FrameMessages.WrongField("transform.translation.x", "2000000", FrameMessages.Coordinate(1e6))),
            },
            new object[]
            {
                "\"w\": 1.0", "\"w\": [1]", 22,
                FrameMessages.OfFrame("box", FrameMessages.WrongField("transform.rotation.w", "[1]", FrameMessages.FiniteNumber)),
            },
            new object[] { "\"frame_id\": \"world\"", "\"frame_id\": \"box\"", 25, FrameMessages.OfFrame("box", FrameMessages.IsOwnParent) },
            new object[]
            {
                "\"frame_id\": \"world\"", "\"frame_id\": 3", 9,
                FrameMessages.OfFrame("box", FrameMessages.WrongField("header.frame_id", "3", FrameMessages.Text)),
            },
            new object[] { "\"child_frame_id\": \"box\",", "", 25, FrameMessages.OfTransform(1, FrameMessages.NoField("child_frame_id")) },
            new object[]
            {
                "\"child_frame_id\": \"box\",", "\"child_frame_id\": \"\",", 11,
                FrameMessages.OfTransform(1, FrameMessages.NoField("child_frame_id")),
            },
            new object[] { "\"y\": 0.0,", "", 17, FrameMessages.OfFrame("box", FrameMessages.NoField("transform.translation.y")) },
            new object[] { "\"y\": 0.0,", "\"y\": 0.0;", 15, FrameMessages.NotTransforms(DropReason.NotJson) },
            new object[]
            {
                "\"frame_id\": \"world\"", "\"frame_id\": \"" + new string('n', 1000) + "\"", 9,
                FrameMessages.OfFrame("box", FrameMessages.LongName("header.frame_id", 1000, ProtocolLimits.NameLength)),
            },
        };

        [TestCaseSource(nameof(InvalidContents))]
        public void Load_InvalidContent_IsRefusedWithTheLineNumber(string good, string bad, int line, string words)
        {
            var pose = RigidTransform.FromXyzRpy(0.5, 0, 0, 0, 0, 0);
            StationaryFrameFile.Save(_path, new TransformsMessage(pose.ToTransform(default, "world", "box")));
            var text = File.ReadAllText(_path);
            Assert.That(text, Does.Contain(good));
            var at = text.IndexOf(good, StringComparison.Ordinal);
            File.WriteAllText(_path, text.Remove(at, good.Length).Insert(at, bad));

            var fault = Assert.Throws<InputException>(() => StationaryFrameFile.Load(_path));

            Assert.That(fault.Message, Is.EqualTo(FrameMessages.FileLine(_path, line, words)));
        }

        [TestCase("", FrameMessages.FileEmpty)]
        [TestCase("{}", FrameMessages.NoTransforms)]
        [TestCase("{\"transforms\": []}", FrameMessages.NoTransforms)]
        public void Load_NoFrames_IsRefusedWithTheReason(string text, string reason)
        {
            File.WriteAllText(_path, text);

            var fault = Assert.Throws<InputException>(() => StationaryFrameFile.Load(_path));

            Assert.That(fault.Message, Is.EqualTo(FrameMessages.FileLine(_path, 1, reason)));
        }

        [Test]
        public void Load_NoFile_IsRefusedWithOneSentence() =>
            Assert.That(() => StationaryFrameFile.Load(_path + "x"), Throws.InstanceOf<InputException>().With.Message.Not.Contains(".;"));

        [TestCase("[]")]
        [TestCase("{\"transforms\": 3}")]
        [TestCase("\0\u0001rubbish")]
        public void Load_OtherContent_IsRefusedWithAOneLineMessage(string text)
        {
            File.WriteAllText(_path, text);

            var fault = Assert.Throws<InputException>(() => StationaryFrameFile.Load(_path));

            Assert.That(fault.Message, Does.StartWith(_path + ", line 1: "));
            Assert.That(fault.Message.Contains('\n'), Is.False);
        }

        [Test]
        public void Load_FrameTwice_IsRefusedWithItsName()
        {
            StationaryFrameFile.Save(_path, new TransformsMessage(Frame("box", 0, 0), Frame("lid", 1, 0), Frame("lid", 2, 0)));

            var fault = Assert.Throws<InputException>(() => StationaryFrameFile.Load(_path));

            Assert.That(fault.Message, Does.EndWith(": " + FrameMessages.OfFrame("lid", FrameMessages.OccursTwice)));
        }

        [Test]
        public void Load_TextAfterTheEnd_IsRefused()
        {
            StationaryFrameFile.Save(_path, new TransformsMessage(Frame("box", 0, 0)));
            File.AppendAllText(_path, "{}");

            Assert.That(() => StationaryFrameFile.Load(_path), Throws.InstanceOf<InputException>());
        }

        [Test]
        public void Save_Frame_WritesOneFieldPerLine()
        {
            StationaryFrameFile.Save(_path, new TransformsMessage(Frame("box", 0.5, 0)));

            Assert.That(File.ReadAllLines(_path).Count(line => line.Contains(':')), Is.GreaterThan(12));
        }
    }
}
