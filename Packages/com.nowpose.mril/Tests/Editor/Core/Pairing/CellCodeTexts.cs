using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Pairing
{
    /// <summary>Valid cell codes as strings.</summary>
    static class CellCodeTexts
    {
        public const string PinText = "AAECAwQFBgcICQoLDA0ODxAREhMUFRYXGBkaGxwdHh8";

        /// <summary>A code with all fields.</summary>
        public const string Whole = "nowpose:cell/1?n=Press%203&h=192.168.10.20&s=47020&w=47021&p=" + PinText + "&o=0.25,-0.1,0.02,0,0,90&m=0.12";

        /// <summary>The shortest code. Its host is this machine, so it needs no pin.</summary>
        public const string Shortest = "nowpose:cell/1?n=a&h=127.0.0.1";

        public static readonly CertificatePin Pin = CertificatePin.Parse("sha256/" + PinText + "=");
    }
}
