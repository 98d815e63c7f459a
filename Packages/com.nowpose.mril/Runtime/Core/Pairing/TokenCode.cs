using System;
using System.Globalization;
using System.Text;
using Nowpose.Protocol;

namespace Nowpose.Pairing
{
    /// <summary>
    /// What the gateway shows for five minutes: a token that one headset may exchange for its own, and the key of that gateway. Secret.
    /// </summary>
    sealed class TokenCode
    {
        public const int Version = 1;

        /// <summary>Nobody guesses 128 bits.</summary>
        public const int TokenBytes = 16;

        internal const string Kind = "token";
        const string Keys = "ptx";
        const long LastUnixSeconds = 253402300799; // 9999-12-31, the last a DateTime knows

        static readonly DateTime UnixEpoch = new DateTime(1970, 1, 1, 0, 0, 0, DateTimeKind.Utc);

        /// <param name="pin">The gateway's public key; null for a gateway without TLS, which is on the headset's own machine.</param>
        /// <param name="token">Base64url of 16 bytes.</param>
        /// <param name="validToUtc">By the gateway's time of day: a hint, for the headset's may be wrong.</param>
        /// <exception cref="InputException">A value cannot be used.</exception>
        public TokenCode(CertificatePin pin, string token, DateTime? validToUtc = null)
            : this(pin, token, validToUtc, null) { }

        TokenCode(CertificatePin pin, string token, DateTime? validToUtc, string text)
        {
            if (!Base64Url.TryRead(token ?? "", TokenBytes, out _))
                throw new InputException("token code: the token is not the base64url of " + TokenBytes + " bytes");
            Pin = pin;
            Token = token;
            ValidToUtc = validToUtc;
            Text = text ?? Write();
        }

        /// <summary>Null for a gateway without TLS.</summary>
        public CertificatePin Pin { get; }

        /// <summary>Never shown or logged.</summary>
        public string Token { get; }

        /// <summary>By the gateway's time of day; null where the code does not say.</summary>
        public DateTime? ValidToUtc { get; }

        /// <summary>What is in the shown code, to the letter. Secret.</summary>
        public string Text { get; }

        /// <param name="text">Of any length; no longer than <see cref="PairingCode.GreatestLength"/> is read.</param>
        /// <exception cref="InputException">It is no token code of this version, or a value cannot be used; one line without the token.</exception>
        public static TokenCode Parse(string text)
        {
            var fields = new CodeFields(text, Kind, Version, Keys);
            var validTo = fields.Count('x', -1, 0, LastUnixSeconds);
            return new TokenCode(
                CellCode.PinOf(fields), fields.Text('t'), validTo < 0 ? (DateTime?)null : UnixEpoch.AddSeconds(validTo), text);
        }

        /// <summary>Whether the token is that cell's gateway's: it is sent nowhere else.</summary>
        public bool IsFor(CellCode cell) => Equals(cell.Pin, Pin);

        /// <summary>Says what it is, not what it holds.</summary>
        public override string ToString() => "token code";

        string Write()
        {
            var text = new StringBuilder(PairingCode.Scheme).Append(Kind).Append('/').Append(Version).Append('?');
            if (Pin != null) text.Append("p=").Append(CellCode.TextOf(Pin)).Append('&');
            text.Append("t=").Append(Token);
            if (ValidToUtc is DateTime end)
                text.Append("&x=").Append(((long)(end - UnixEpoch).TotalSeconds).ToString(CultureInfo.InvariantCulture));
            return text.ToString();
        }
    }
}
