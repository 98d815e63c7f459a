using System;
using System.Collections.Generic;
using System.Text;

namespace Nowpose.Session
{
    /// <summary>Describes several joints in one line; groups consecutive joints with the same description.</summary>
    static class JointStatusText
    {
        /// <summary>Returns for example "joint a1: assumed at rest for 9 s; joints a3, a4: no data for 4 s"; empty without joints.</summary>
        /// <param name="describe">Describes one joint without its name; null for <see cref="JointStatus.Description"/>.</param>
        public static string Of(IEnumerable<JointStatus> joints, Func<JointStatus, string> describe = null)
        {
            var text = new StringBuilder();
            var names = new List<string>();
            string present = null;
            foreach (var joint in joints)
            {
                var description = describe == null ? joint.Description : describe(joint);
                if (present != null && description != present) Append(text, names, present);
                present = description;
                names.Add(joint.Joint);
            }
            if (names.Count > 0) Append(text, names, present);
            return text.ToString();
        }

        static void Append(StringBuilder text, List<string> names, string description)
        {
            if (text.Length > 0) text.Append("; ");
            text.Append(names.Count == 1 ? "joint " : "joints ").Append(string.Join(", ", names)).Append(": ").Append(description);
            names.Clear();
        }
    }
}
