using System.Text.Json;
using System.Text.Json.Serialization;

namespace Nowpose.Gateway.Status;

/// <summary>Writes NaN and infinity as null, so that an invalid number from one client does not make the whole JSON response invalid.</summary>
sealed class FiniteNumbers : JsonConverter<double>
{
    public override double Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) => reader.GetDouble();

    public override void Write(Utf8JsonWriter writer, double value, JsonSerializerOptions options)
    {
        if (double.IsFinite(value)) writer.WriteNumberValue(value);
        else writer.WriteNullValue();
    }
}
