using System.Linq;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Tests.Core.Protocol.RosbridgeTexts;

namespace Nowpose.Tests.Core.Protocol
{
    /// <summary>Checks the JSON that the reader accepts: its form, its depth and its size.</summary>
    public class RosbridgeJsonTests
    {
        [TestCase("")]
        [TestCase(" ")]
        [TestCase("[]")]
        [TestCase("1")]
        [TestCase("null")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\"} {}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\"}x")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\"")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",}")]
        [TestCase("{\"op\":\"status\",,\"msg\":\"a\"}")]
        [TestCase("{'op':\"status\",\"msg\":\"a\"}")]
        [TestCase("{op:\"status\",\"msg\":\"a\"}")]
        [TestCase("{\"op\":'status',\"msg\":\"a\"}")]
        [TestCase("{\"op\":\"status\",/*c*/\"msg\":\"a\"}")]
        [TestCase("//c\n{\"op\":\"status\",\"msg\":\"a\"}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":[1,]}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":[,1]}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":0x10}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":010}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":.5}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":+5}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":5.}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":1e}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":undefined}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":new Date(1)}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":[1}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"\\q\"}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"\\u12g4\"}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\nb\"}")]
        [TestCase("\uFEFF{\"op\":\"status\",\"msg\":\"a\"}")]
        public void TryRead_NotExactlyOneValidJsonObject_IsRefused(string text) => Refuse(text, DropReason.NotJson);

        [TestCase(14, true)]
        [TestCase(15, false)]
        [TestCase(10_000, false)]
        public void TryRead_NestingDepth_IsLimitedTo16Levels(int inside, bool expected)
        {
            // The message and its msg object add two levels.
            var nested = new string('[', inside) + new string(']', inside);
            var text = State("[\"a\"]", "[1]", ",\"effort\":" + nested);

            if (expected) Read(text);
            else Refuse(text, DropReason.TooDeep);
        }

        [Test]
        public void TryRead_UnclosedNestingOf10000Levels_IsRefusedAsTooDeep() =>
            Refuse("{\"op\":" + string.Concat(Enumerable.Repeat("{\"a\":[", 10_000)), DropReason.TooDeep);

        [TestCase("x", 0, true)]
        [TestCase("x", 1, false)]
        [TestCase("é", 0, true)]
        [TestCase("é", 1, false)]
        public void TryRead_MessageSize_IsLimitedTo64KiBOfUtf8(string character, int over, bool expected)
        {
            var text = Sized(character, 64 * 1024 + over, "/joint_states", "name");

            if (expected) Read(text);
            else Refuse(text, DropReason.TooLarge);
        }

        [TestCase(0, true)]
        [TestCase(1, false)]
        public void TryRead_LongDescription_IsLimitedTo1MiB(int over, bool expected)
        {
            var text = Sized("x", 1024 * 1024 + over, "/robot_description", "data");

            if (expected) Assert.That(Read(text).Data.Length, Is.GreaterThan(1_000_000));
            else Refuse(text, DropReason.TooLarge);
        }

        // Returns a message of exactly this size in bytes. The characters that fill it are in an unused field or in the data.
        static string Sized(string character, int bytes, string topic, string field)
        {
            string Make(string fill) => field == "data"
                ? Publish("{\"data\":\"" + fill + "\"}", topic)
                : State("[\"a\"]", "[1]", ",\"fill\":\"" + fill + "\"");

            var room = bytes - System.Text.Encoding.UTF8.GetByteCount(Make(""));
            var width = System.Text.Encoding.UTF8.GetByteCount(character);
            var fill = string.Concat(Enumerable.Repeat(character, room / width)) + new string('x', room % width);
            return Make(fill);
        }

        [Test]
        public void TryRead_DamagedMessages_NeverThrows()
        {
            const int Seed = 3;
            const string Alphabet = "{}[]\",:0123456789.eE+-\\/ntfuNI*' \0\uD800x";
            var random = new System.Random(Seed);
            var whole = State("[\"a\",\"b\"]", "[1.5,-2e3]", ",\"velocity\":[0.25,null],\"effort\":[NaN]");
            var refused = 0;
            for (var i = 0; i < 20_000; i++)
            {
                var damaged = whole.ToCharArray();
                for (var n = random.Next(1, 4); n > 0; n--)
                    damaged[random.Next(damaged.Length)] = Alphabet[random.Next(Alphabet.Length)];
                var text = new string(damaged, 0, random.Next(8) == 0 ? random.Next(damaged.Length) : damaged.Length);

                Assert.DoesNotThrow(() => refused += RosbridgeReader.TryRead(text, out _, out _) ? 0 : 1, text + ", seed " + Seed);
            }

            Assert.That(refused, Is.GreaterThan(10_000));
        }
    }
}
