using System.Text.Json;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The result of the pictures as JSON.</summary>
static class VlcJson
{
    public static string Of(VlcResult result) => JsonText.Of(isIndented: true, json =>
    {
        json.WriteStartObject();
        json.WriteNumber("pictures", result.Pictures.Count);
        json.WriteNumber("decoded", result.Read.Count);
        json.WriteNumber("rejected", result.Rejected);
        Write(json, "visu_ms_mean", result.Mean);
        Write(json, "visu_ms_sd", result.Deviation);
        json.WriteStartArray("per_picture");
        foreach (var picture in result.Pictures)
        {
            json.WriteStartObject();
            json.WriteString("file", picture.File);
            Write(json, "led_ms", picture.IsRead ? Rounded(picture.LedMs) : null);
            Write(json, "headset_ms", picture.IsRead ? picture.HeadsetMs : null);
            Write(json, "visu_ms", picture.IsRead ? Rounded(picture.VisuMs) : null);
            json.WriteEndObject();
        }
        json.WriteEndArray();
        json.WriteEndObject();
    });

    static double? Rounded(double ms) => Math.Round(ms, 3);

    static void Write(Utf8JsonWriter json, string name, double? value)
    {
        if (value is double number) json.WriteNumber(name, number);
        else json.WriteNull(name);
    }
}
