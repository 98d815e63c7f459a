using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using Nowpose.Session;

namespace Nowpose.Unity
{
    /// <summary>How much of each joint's error is removed, in one line; made anew only when a number in it changes.</summary>
    sealed class JointErrorLine
    {
        readonly StringBuilder _builder = new StringBuilder();
        int?[] _percents = Array.Empty<int?>();
        string _text = "";

        /// <summary>"arm_joint_1 92 %, …" from the base on; a joint that rests, or is not known yet, has no number. Empty without joints.</summary>
        public string Of(IReadOnlyList<JointError> joints)
        {
            var isSame = joints.Count == _percents.Length;
            if (!isSame) _percents = new int?[joints.Count];
            for (var i = 0; i < joints.Count; i++)
            {
                var reduction = joints[i].Error?.Reduction;
                var percent = reduction.HasValue ? (int)Math.Round(100 * reduction.Value) : (int?)null;
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
                var percent = _percents[i].HasValue ? _percents[i].Value.ToString(CultureInfo.InvariantCulture) + " %" : NumberTexts.Unknown;
                _builder.Append(joints[i].Joint).Append(' ').Append(percent);
            }
            return _builder.ToString();
        }
    }
}
