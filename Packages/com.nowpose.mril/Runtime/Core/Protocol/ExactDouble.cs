using System;

namespace Nowpose.Protocol
{
    /// <summary>Converts decimal numbers to the nearest doubles, with 128-bit integer arithmetic. Allocates nothing.</summary>
    /// <remarks>
    /// Utf8Parser and double.Parse of Unity's Mono and IL2CPP multiply by rounded powers of ten, so the last bit may be wrong, and a
    /// sample would differ from the number that was sent.
    /// </remarks>
    static class ExactDouble
    {
        /// <summary>Maximum magnitude of a decimal exponent: 5^27 is the largest power of five below 2^64.</summary>
        public const int MaxExponent = 27;

        const int DroppedBits = 64 - 53;
        const int ExponentBias = 1023, FractionBits = 52;
        const ulong Low = 0xFFFF_FFFF;

        static readonly ulong[] PowersOfFive = CreatePowers();

        /// <summary>Returns the double nearest to digits × 10^exponent; for a tie, the double whose last bit is zero.</summary>
        /// <param name="digits">The decimal digits as an integer, not zero.</param>
        /// <param name="exponent">-<see cref="MaxExponent"/> to <see cref="MaxExponent"/>.</param>
        public static double Of(ulong digits, int exponent) =>
            // 10^exponent is 5^exponent · 2^exponent, and a power of two does not change the fraction of a double.
            exponent < 0 ? Quotient(digits, PowersOfFive[-exponent], exponent) : Product(digits, PowersOfFive[exponent], exponent);

        static double Product(ulong a, ulong b, int exponent)
        {
            var low = (a & Low) * (b & Low);
            var middle = (a >> 32) * (b & Low) + (low >> 32);
            var other = (a & Low) * (b >> 32) + (middle & Low);
            var high = (a >> 32) * (b >> 32) + (middle >> 32) + (other >> 32);
            low = other << 32 | (low & Low);
            if (high == 0) return Rounded(low, false, exponent);
            var shift = LeadingZeros(high);
            return shift == 0
                ? Rounded(high, low != 0, exponent + 64)
                : Rounded(high << shift | low >> (64 - shift), low << shift != 0, exponent + 64 - shift);
        }

        static double Quotient(ulong dividend, ulong divisor, int exponent)
        {
            // Normalises both numbers so that the highest bit is set, and halves the dividend so that the quotient fits into 64 bits.
            var (up, down) = (LeadingZeros(dividend), LeadingZeros(divisor));
            dividend <<= up;
            divisor <<= down;
            var rest = dividend >> 1;
            var quotient = Digit(ref rest, dividend << 63 >> 32, divisor) << 32;
            quotient |= Digit(ref rest, 0, divisor);
            return Rounded(quotient, rest != 0, exponent + down - up - 63);
        }

        // Knuth's long division (The Art of Computer Programming 2, 4.3.1 D), one step: returns the next 32-bit digit of the quotient.
        static ulong Digit(ref ulong rest, ulong next, ulong divisor)
        {
            var digit = rest / (divisor >> 32);
            var left = rest % (divisor >> 32);
            while (left <= Low && (digit > Low || digit * (divisor & Low) > (left << 32 | next)))
            {
                digit--;
                left += divisor >> 32;
            }

            rest = unchecked((rest << 32 | next) - digit * divisor);
            return digit;
        }

        // isMore: whether nonzero bits were dropped below the lowest of these bits.
        static double Rounded(ulong bits, bool isMore, int exponent)
        {
            var shift = LeadingZeros(bits);
            bits <<= shift;
            var kept = bits >> DroppedBits;
            var dropped = bits & ((1UL << DroppedBits) - 1);
            const ulong half = 1UL << (DroppedBits - 1);
            if (dropped > half || (dropped == half && (isMore || (kept & 1) != 0))) kept++;
            return (long)kept * BitConverter.Int64BitsToDouble((long)(exponent - shift + DroppedBits + ExponentBias) << FractionBits);
        }

        static int LeadingZeros(ulong value)
        {
            var count = 0;
            for (var bits = 32; bits > 0; bits /= 2)
            {
                if (value >> (64 - bits) != 0) continue;
                count += bits;
                value <<= bits;
            }

            return count;
        }

        static ulong[] CreatePowers()
        {
            var powers = new ulong[MaxExponent + 1];
            powers[0] = 1;
            for (var i = 1; i < powers.Length; i++) powers[i] = 5 * powers[i - 1];
            return powers;
        }
    }
}
