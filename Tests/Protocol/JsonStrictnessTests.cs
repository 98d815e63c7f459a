using System.Text.Json;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Protocol;

public class JsonStrictnessTests
{
    const int Seed = 17;

    // Excludes N and I, because the reader accepts NaN and Infinity by design, and System.Text.Json rejects them.
    const string Alphabet = "{}[]\",:0123456789.eE+-\\/tfnu'* \t\u0001x";

    [Test]
    public void TryRead_DamagedTexts_AgreesWithSystemTextJson()
    {
        var random = new Random(Seed);
        const string Whole = """{"op":"status","msg":"a\n\u00e9\"b","x":[1,-0.5e+3,{"k":null,"l":[true,false,[]]},{}],"level":"none"} """;
        var valid = 0;
        for (var i = 0; i < 50_000; i++)
        {
            var text = Damage(Whole, random);

            var expected = IsObject(text);
            RosbridgeReader.TryRead(text, out _, out var reason);

            if ((reason != DropReason.NotJson) != expected) Assert.Fail($"{text} {(expected ? "is" : "is no")} JSON, but the reader states {reason}; seed {Seed}");
            valid += expected ? 1 : 0;
        }

        Assert.That(valid, Is.InRange(1_000, 49_000));
    }

    static string Damage(string whole, Random random)
    {
        var text = whole.ToCharArray();
        for (var n = random.Next(1, 3); n > 0; n--)
            text[random.Next(text.Length)] = Alphabet[random.Next(Alphabet.Length)];
        return new string(text);
    }

    static bool IsObject(string text)
    {
        try
        {
            using var document = JsonDocument.Parse(text);
            return document.RootElement.ValueKind == JsonValueKind.Object;
        }
        catch (JsonException)
        {
            return false;
        }
    }
}
