using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Nowpose.Session;

namespace Nowpose.Unity.Status
{
    /// <summary>
    /// Lists, in one line, the percentage of each joint's error that the prediction removes. Creates a new string only when a number in it changes.
    /// </summary>
    sealed class JointErrorLine
    {
        readonly StringBuilder _builder = new StringBuilder();
        (int? Reduction, int? Uncertainty)[] _percents = Array.Empty<(int?, int?)>();
        string _text = "";

        /// <summary>
        /// Returns a string such as "arm_joint_1 92 ± 3 %, arm_joint_2 88 ± 4 %", in order from the base. A joint whose error is unknown, for example
        /// because it is at rest, has no number. The string is empty if the robot has no joints.
        /// </summary>
        public string Of(IReadOnlyList<JointError> joints)
        {
            var isSame = joints.Count == _percents.Length;
            if (!isSame) _percents = new (int?, int?)[joints.Count];
            for (var i = 0; i < joints.Count; i++)
            {
                var percent = (Percent(joints[i].Error?.Reduction), Percent(joints[i].Error?.ReductionUncertainty));
                isSame &= percent == _percents[i];
                _percents[i] = percent;
            }
            return isSame ? _text : _text = Text(joints);
        }

        string Text(IReadOnlyList<JointError> joints)
        {
            _builder.Clear();
            for (var i = 0; i < joints.Count; i++)
            {
                if (i > 0) _builder.Append(", ");
                _builder.Append(joints[i].Joint).Append(' ').Append(Text(_percents[i]));
            }
            return _builder.ToString();
        }

        static string Text((int? Reduction, int? Uncertainty) percent)
        {
            if (!percent.Reduction.HasValue) return NumberTexts.Unknown;
            var interval = percent.Uncertainty.HasValue ? " ± " + percent.Uncertainty.Value.ToString(CultureInfo.InvariantCulture) : "";
            return percent.Reduction.Value.ToString(CultureInfo.InvariantCulture) + interval + " %";
        }

        static int? Percent(double? share) => share.HasValue ? (int)Math.Round(100 * share.Value) : (int?)null;
    }
}
