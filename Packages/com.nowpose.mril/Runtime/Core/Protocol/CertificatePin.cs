using System;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Messages;

namespace Nowpose.Protocol
{
    /// <summary>SHA-256 of a certificate's public key (SubjectPublicKeyInfo), as in RFC 7469; unchanged by a renewal with the same key.</summary>
    public sealed class CertificatePin : IEquatable<CertificatePin>
    {
        const string Prefix = "sha256/";
        const int HashBytes = 32, ComparedCharacters = 12;

        readonly byte[] _hash;

        CertificatePin(byte[] hash) => _hash = hash;

        /// <summary>
        /// Part that a person compares: the first characters after "sha256/" and an ellipsis. All user interfaces show the same part.
        /// </summary>
        public string Beginning => Convert.ToBase64String(_hash).Substring(0, ComparedCharacters) + "…";

        /// <summary>Reads base64 of 32 bytes, with or without the prefix "sha256/"; ignores surrounding white space.</summary>
        /// <exception cref="InputException">The text has another form.</exception>
        public static CertificatePin Parse(string text)
        {
            var trimmed = (text ?? "").Trim();
            var base64 = trimmed.StartsWith(Prefix, StringComparison.Ordinal) ? trimmed.Substring(Prefix.Length) : trimmed;
            var hash = new byte[HashBytes + 1];
            // The buffer has one extra byte, to distinguish 33 bytes from 32; longer values are rejected as well.
            if (!Convert.TryFromBase64String(base64, hash, out var length) || length != HashBytes)
                throw new InputException(CertificateMessages.PinInvalid(trimmed));
            return new CertificatePin(hash.AsSpan(0, HashBytes).ToArray());
        }

        /// <summary>Computes the pin of a certificate's public key.</summary>
        /// <exception cref="InputException">The bytes are not an X.509 certificate.</exception>
        public static CertificatePin Of(X509Certificate certificate)
        {
            // Unity's Mono has no ExportSubjectPublicKeyInfo, so the key is extracted from the certificate's bytes.
            if (!SubjectPublicKeyInfo.TryFind(certificate.GetRawCertData(), out var info))
                throw new InputException(CertificateMessages.NotX509);
            using (var sha = SHA256.Create())
                return new CertificatePin(sha.ComputeHash(info.ToArray()));
        }

        /// <summary>Returns whether the certificate has the pinned key; false for invalid bytes. Does not check the validity period.</summary>
        public bool Matches(X509Certificate certificate) =>
            certificate != null && SubjectPublicKeyInfo.TryFind(certificate.GetRawCertData(), out _) && Equals(Of(certificate));

        public bool Equals(CertificatePin other) => other != null && _hash.AsSpan().SequenceEqual(other._hash);
        public override bool Equals(object obj) => Equals(obj as CertificatePin);
        public override int GetHashCode() => BitConverter.ToInt32(_hash, 0);
        public override string ToString() => Prefix + Convert.ToBase64String(_hash);
    }
}
