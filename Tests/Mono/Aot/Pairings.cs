using System;
using System.IO;
using System.Threading.Tasks;
using Nowpose.Pairing;
using Nowpose.Protocol;

namespace Nowpose.Mono.Aot
{
    /// <summary>Pairs with a cell through its two codes, saves the pairing and loads it again.</summary>
    static class Pairings
    {
        public static void Check()
        {
            var pin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));
            var now = HeadsetTime.FromSeconds(100);
            using var flow = new PairingFlow(PairedCells.None, "headset", (gateway, token, cancel) => Task.FromResult(PairingAnswer.Accepted("own")));

            flow.See(new CellCode("Press 3", "10.0.0.7", pin, MarkerOffset.Parse("0,0,0", "")).Text, now);
            flow.Tick(now);
            flow.Accept();
            flow.See(new TokenCode(pin, "AAAAAAAAAAAAAAAAAAAAAA").Text, now);
            for (var i = 0; i < 10; i++) flow.Tick(now += TimeSpan.FromMilliseconds(16));

            Program.Require(flow.Cells.Used?.Token == "own", "paired: " + flow.Words);

            var path = Path.GetTempFileName();
            try
            {
                PairedCellsFile.Save(path, flow.Cells);
                Program.Require(PairedCellsFile.Load(path, out var problem, out _).Used?.Cell == "Press 3", "loaded: " + problem);
            }
            finally
            {
                File.Delete(path);
            }
        }
    }
}
