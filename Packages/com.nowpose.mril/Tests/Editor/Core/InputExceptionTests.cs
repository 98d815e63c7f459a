using System.Linq;
using System.Text;
using NUnit.Framework;

namespace Nowpose.Tests.Core
{
    public class InputExceptionTests
    {
        [Test]
        public void OneLine_LongText_KeepsBeginningAndEndWithinTheLength()
        {
            var text = "file.urdf:3: " + new string('x', 500) + "; allowed: 1 to 5";

            var line = InputException.OneLine(text, 100);

            Assert.That(line, Does.StartWith("file.urdf:3: x").And.EndsWith("x; allowed: 1 to 5").And.Contain(" … "));
            Assert.That(line.Length, Is.LessThanOrEqualTo(100));
        }

        [Test]
        public void OneLine_CutInsideASurrogatePair_KeepsOrDropsTheWholePair([Values(0, 1)] int before)
        {
            var text = new string('x', before) + string.Concat(Enumerable.Repeat("\U0001F916", 200));

            var line = InputException.OneLine(text, 100);

            Assert.That(new UTF8Encoding(false, throwOnInvalidBytes: true).GetBytes(line), Is.Not.Empty);
            Assert.That(line.Length, Is.LessThanOrEqualTo(100));
        }

        [Test]
        public void OneLine_ControlCharacters_AreReplacedBySpaces() =>
            Assert.That(InputException.OneLine("a\nb\u2028c\td", 100), Is.EqualTo("a b c d"));
    }
}
