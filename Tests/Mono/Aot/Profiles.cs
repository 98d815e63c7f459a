using System;
using System.IO;
using Nowpose.Latency;
using Nowpose.Latency.Profile;

namespace Nowpose.Mono.Aot
{
    /// <summary>Reads a latency profile, saves it and loads it again.</summary>
    static class Profiles
    {
        const string Text = @"{""format"": ""nowpose-latency-profile"", ""version"": 1, ""visu_ms"": 40.2, ""visu_spread_ms"": 1.1,
            ""device"": ""HoloLens 2"", ""display_hz"": 60, ""measured"": ""2026-11-21T10:00:00Z"", ""method"": ""vlc"", ""measurements"": 240}";

        public static void Check()
        {
            var path = Path.GetTempFileName();
            try
            {
                LatencyProfileFile.Save(path, LatencyProfileJson.Read(Text, "text"));
                var loaded = LatencyProfileFile.Load(path);

                Program.Require(loaded.Visualisation.Length == TimeSpan.FromTicks(402_000) && loaded.Device == "HoloLens 2", "profile");
            }
            finally
            {
                File.Delete(path);
            }
        }
    }
}
