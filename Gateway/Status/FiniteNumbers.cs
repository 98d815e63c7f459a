using System.Text.Json;
using System.Text.Json.Serialization;

namespace Nowpose.Gateway.Status;

/// <summary>Writes a number that JSON has no word for as null: one peer's nonsense must not take the whole answer from everybody.</summary>
sealed class FiniteNumbers : JsonConverter<double>
{
    public override double Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) => reader.GetDouble();

    public override void Write(Utf8JsonWriter writer, double value, JsonSerializerOptions options)
    {
        if (double.IsFinite(value)) writer.WriteNumberValue(value);
        else writer.WriteNullValue();
    }
}
