using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Pairing
{
    /// <summary>Simulates the pairing of a headset in virtual time, with the codes of two cells. The test sets the gateways' answers.</summary>
    sealed class SimulatedPairing : IDisposable
    {
        public const string OwnToken = "own-token";

        public static readonly CertificatePin Pin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));
        public static readonly CertificatePin OtherPin = CertificatePin.Parse("sha256/AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8=");
        public static readonly string Cell = CodeOf("Press 3", "10.0.0.7", Pin);
        public static readonly string Token = TokenOf(1, Pin);
        public static readonly string Other = CodeOf("Press 4", "10.0.0.9", OtherPin);

        public SimulatedPairing() => Restart(PairedCells.None);

        public PairingFlow Flow { get; private set; }

        public HeadsetTime Now { get; set; } = HeadsetTime.FromSeconds(100);

        /// <summary>Gets the gateways that tokens were sent to, in order.</summary>
        public List<ConnectionSettings> SentTo { get; } = new List<ConnectionSettings>();

        /// <summary>Gets the tokens that were sent, in order.</summary>
        public List<string> Sent { get; } = new List<string>();

        /// <summary>Gets the pending answer to the last token that was sent.</summary>
        public TaskCompletionSource<PairingAnswer> Answer { get; private set; }

        public static string CodeOf(string cell, string host, CertificatePin pin, double x = 0) =>
            new CellCode(cell, host, pin, MarkerOffset.Parse(MarkerOffset.Write(x) + ",0,0", "")).Text;

        public static string TokenOf(byte number, CertificatePin pin) =>
            new TokenCode(pin, Convert.ToBase64String(new byte[] { number, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }).TrimEnd('=')).Text;

        public void Restart(PairedCells cells)
        {
            Flow?.Dispose();
            Flow = new PairingFlow(cells, "headset 7", Send);
        }

        /// <summary>Runs one frame with these codes in view.</summary>
        public PairingChange Frame(params string[] inView)
        {
            Now += TimeSpan.FromTicks(TimeSpan.TicksPerSecond / 60);
            foreach (var text in inView) Flow.See(text, Now);
            return Flow.Tick(Now);
        }

        /// <summary>
        /// Runs frames for 1.1 s with these codes in view. After this time, the flow may ask the next question, and a cell other than the
        /// cell in use counts as looked at.
        /// </summary>
        public void Look(params string[] inView)
        {
            for (var end = Now + TimeSpan.FromTicks(TimeSpan.TicksPerSecond * 11 / 10); Now < end;) Frame(inView);
        }

        public void Agree(string code)
        {
            Frame(code);
            Flow.Accept();
            Look();
        }

        public void Pair(string code, string token)
        {
            Agree(code);
            Frame(token);
            Answer.SetResult(PairingAnswer.Accepted(OwnToken));
            Frame();
        }

        public void Dispose() => Flow.Dispose();

        Task<PairingAnswer> Send(ConnectionSettings gateway, string token, CancellationToken cancel)
        {
            SentTo.Add(gateway);
            Sent.Add(token);
            Answer = new TaskCompletionSource<PairingAnswer>();
            return Answer.Task;
        }
    }
}
