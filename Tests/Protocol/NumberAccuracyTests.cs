using System.Globalization;
using System.Numerics;
using System.Text;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Protocol;

/// <summary>Tests that numbers in messages are read as the nearest doubles. The reference is exact arithmetic, or .NET's parser.</summary>
public class NumberAccuracyTests
{
    const int Seed = 41;

    [Test]
    public void ToDouble_FormattedDoubles_AgreesWithDotNet()
    {
        var random = new Random(Seed);
        for (var i = 0; i < 200_000; i++)
        {
            var value = (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-30, 30));

            foreach (var format in new[] { "R", "G17", "E16", "F12" })
                AssertAgreesWithDotNet(value.ToString(format, CultureInfo.InvariantCulture));
        }
    }

    [Test]
    public void ToDouble_RandomDigitsAndExponents_AgreesWithDotNet()
    {
        var random = new Random(Seed);
        for (var i = 0; i < 200_000; i++)
        {
            var text = Digits(random, random.Next(1, 26));
            if (random.Next(2) == 0) text += "." + Digits(random, random.Next(1, 26), mayBeginWithZero: true);
            if (random.Next(2) == 0) text += "e" + random.Next(-340, 340).ToString(CultureInfo.InvariantCulture);

            AssertAgreesWithDotNet(text);
        }
    }

    // Halfway between two adjacent doubles, the even one is correct. One digit more and one digit less are tested, too.
    [Test]
    public void ToDouble_HalfwayBetweenTwoDoubles_ReturnsTheEvenDouble()
    {
        var random = new Random(Seed);
        for (var i = 0; i < 50_000; i++)
        {
            // The value has 54 bits, one more than a double, and its last bit is 1.
            var halfway = new BigInteger((1L << 53) + random.NextInt64(1L << 53) | 1);
            var shift = random.Next(0, 9);
            var text = (halfway << shift).ToString(CultureInfo.InvariantCulture);

            var value = AssertAgreesWithDotNet(text);

            if ((BitConverter.DoubleToInt64Bits(value) & 1) != 0) Assert.Fail($"{text} is even, seed {Seed}");
            foreach (var apart in new[] { -1, 1 })
                AssertAgreesWithDotNet(((halfway << shift) * 10 + apart).ToString(CultureInfo.InvariantCulture) + "e-1");
        }
    }

    [TestCase("0", 0.0)]
    [TestCase("-0.0", -0.0)]
    [TestCase("0e99999999999", 0.0)]
    [TestCase("5e-324", double.Epsilon)]
    [TestCase("2.4703282292062327e-324", 0.0)]
    [TestCase("1e-99999999999", 0.0)]
    [TestCase("1.7976931348623157e308", double.MaxValue)]
    [TestCase("1.7976931348623159e308", double.PositiveInfinity)]
    [TestCase("-1e309", double.NegativeInfinity)]
    [TestCase("1e99999999999", double.PositiveInfinity)]
    [TestCase("9007199254740993", 9007199254740992.0)]
    [TestCase("18446744073709551615", 18446744073709551616.0)]
    public void ToDouble_LimitsOfTheRange_ReturnsTheNearestDouble(string text, double expected)
    {
        Assert.That(BitConverter.DoubleToInt64Bits(Parse(text)), Is.EqualTo(BitConverter.DoubleToInt64Bits(expected)));
    }

    [Test]
    public void ToDouble_ManyDigits_UsesAllOfThem()
    {
        var half = "0." + new string('0', 400) + "1" + new string('0', 300) + "e401";

        Assert.That(Parse(half), Is.EqualTo(1));
        Assert.That(Parse(new string('9', 400)), Is.EqualTo(double.PositiveInfinity));
    }

    // Compares without NUnit's constraints, and formats the message only on failure, because both together take ten times as long as the parsing.
    static double AssertAgreesWithDotNet(string text)
    {
        var value = Parse(text);
        var expected = double.Parse(text, CultureInfo.InvariantCulture);
        if (!value.Equals(expected)) Assert.Fail($"{text} is read as {value:R}, not {expected:R}; seed {Seed}");
        return value;
    }

    static double Parse(string text)
    {
        if (!JsonNumber.TryScan(Encoding.ASCII.GetBytes(text), out var number) || number.Length != text.Length) Assert.Fail(text + " is not read as a number");
        return number.ToDouble();
    }

    static string Digits(Random random, int count, bool mayBeginWithZero = false)
    {
        var digits = new StringBuilder();
        for (var i = 0; i < count; i++) digits.Append((char)('0' + random.Next(i == 0 && !mayBeginWithZero ? 1 : 0, 10)));
        return digits.ToString();
    }
}
