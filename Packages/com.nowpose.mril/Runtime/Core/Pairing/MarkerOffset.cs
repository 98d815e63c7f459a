using System;
using System.Globalization;
using Nowpose.Kinematics;
using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>A marker's pose in the robot's base frame as a person measures it: metres and degrees, with six decimals.</summary>
    /// <remarks>
    /// Like a URDF origin, but with angles in degrees: rotations about the base frame's fixed x, then y, then z axis. The marker frame has
    /// its origin in the centre of the print, x to the right along the print, y to its upper edge, and z out of the print.
    /// </remarks>
    sealed class MarkerOffset
    {
        public const double MaxMetres = 100;
        public const double MaxDegrees = 360;

        const int Decimals = 6, Numbers = 6;

        readonly double[] _numbers;

        MarkerOffset(double[] numbers, string what)
        {
            var names = new[] { "x", "y", "z", "roll", "pitch", "yaw" };
            for (var i = 0; i < Numbers; i++)
            {
                var max = i < 3 ? MaxMetres : MaxDegrees;
                var value = SettingRange.Require(numbers[i], -max, max, what + ", " + names[i], i < 3 ? "m" : "degrees");
                // Adding 0.0 turns −0 into 0.
                numbers[i] = Math.Round(value, Decimals) + 0.0;
            }
            _numbers = numbers;
        }

        /// <summary>Reads numbers separated by commas: x,y,z in metres and roll,pitch,yaw in degrees, or only the first three.</summary>
        /// <param name="what">Name of the value in messages.</param>
        /// <exception cref="InputException">The text does not have this form.</exception>
        public static MarkerOffset Parse(string text, string what)
        {
            var words = (text ?? "").Split(',');
            if (words.Length != Numbers && words.Length != 3)
                throw new InputException(PairingCodeMessages.OffsetCount(what, words.Length));
            var numbers = new double[Numbers];
            for (var i = 0; i < words.Length; i++)
                if (!TryReadNumber(words[i], out numbers[i]))
                    throw new InputException(PairingCodeMessages.OffsetNumber(what, i + 1));
            return new MarkerOffset(numbers, what);
        }

        /// <summary>Returns the pose of the marker frame in the base frame.</summary>
        public RigidTransform ToPose() => RigidTransform.FromXyzRpy(
            _numbers[0], _numbers[1], _numbers[2], Radians(_numbers[3]), Radians(_numbers[4]), Radians(_numbers[5]));

        /// <summary>Formats the offset for <see cref="Parse"/>: three numbers ("0.25,-0.1,0") without a rotation, otherwise six.</summary>
        public override string ToString()
        {
            var count = _numbers[3] == 0 && _numbers[4] == 0 && _numbers[5] == 0 ? 3 : Numbers;
            return string.Join(",", Array.ConvertAll(_numbers.AsSpan(0, count).ToArray(), Write));
        }

        internal static string Write(double number) => number.ToString("0.######", CultureInfo.InvariantCulture);

        /// <summary>
        /// Reads a decimal number with an optional minus sign, one to three digits before the decimal point and at most six digits after it.
        /// </summary>
        /// <remarks>Rejects exponents, spaces, infinities and digits of other alphabets, which parsers treat differently.</remarks>
        public static bool TryReadNumber(string text, out double number)
        {
            number = 0;
            var digits = text.StartsWith('-') ? text.Substring(1) : text;
            var point = digits.IndexOf('.');
            var whole = point < 0 ? digits.Length : point;
            if (whole < 1 || whole > 3 || (point >= 0 && (digits.Length - point < 2 || digits.Length - point > Decimals + 1))) return false;
            foreach (var c in digits)
                if (c != '.' && (c < '0' || c > '9')) return false;
            return double.TryParse(text, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out number);
        }

        static double Radians(double degrees) => degrees * Math.PI / 180;
    }
}
