using System;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>Robot description from the gateway, parsed and compared with the displayed robot. Immutable.</summary>
    sealed class ReceivedDescription
    {
        /// <summary>No description has been received yet.</summary>
        public static readonly ReceivedDescription None = new ReceivedDescription();

        ReceivedDescription() { }

        public string Text { get; private set; }
        public RobotModel Model { get; private set; }
        public RobotDescriptionMatch Match { get; private set; }

        /// <param name="fault">Error of the text, in one line; null without an error.</param>
        public static bool TryRead(string text, RobotModel displayed, out ReceivedDescription described, out string fault)
        {
            described = null;
            fault = null;
            try
            {
                var model = UrdfReader.Read(text, RosTopics.RobotDescription);
                var isSame = model.SourceHash == displayed.SourceHash;
                described = new ReceivedDescription
                {
                    Text = text,
                    Model = model,
                    Match = isSame ? RobotDescriptionMatch.Same : RobotDescriptionMatch.Different,
                };
                return true;
            }
            catch (InputException notUrdf)
            {
                fault = notUrdf.Message;
                return false;
            }
        }
    }
}
