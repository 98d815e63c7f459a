using System.Text.Json;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Formats the results of the pictures as JSON.</summary>
static class VlcJson
{
    /// <param name="profile">Profile that supplies the mean and the deviation. If null, they are computed from the pictures near the median.</param>
    public static string Of(VlcResult result, LatencyProfile profile) => JsonText.Of(isIndented: true, json =>
    {
        json.WriteStartObject();
        json.WriteNumber("pictures", result.Pictures.Count);
        json.WriteNumber("decoded", result.Read.Count);
        json.WriteNumber("rejected", result.Rejected);
        Write(json, "visu_ms_mean", profile?.Visualisation.Length.TotalMilliseconds ?? result.Mean);
        Write(json, "visu_ms_sd", profile?.Spread.TotalMilliseconds ?? result.Deviation);
        json.WriteStartArray("rejected_pictures");
        foreach (var picture in result.Pictures.Where(picture => !picture.IsRead))
        {
            json.WriteStartObject();
            json.WriteString("file", picture.File);
            json.WriteString("reason", picture.Fault);
            json.WriteEndObject();
        }
        json.WriteEndArray();
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
