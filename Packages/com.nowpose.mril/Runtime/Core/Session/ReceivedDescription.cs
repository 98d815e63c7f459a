using System;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Session
{
    /// <summary>The robot as the gateway describes it, read and compared with the one displayed. Immutable.</summary>
    sealed class ReceivedDescription
    {
        /// <summary>Nothing has been described yet.</summary>
        public static readonly ReceivedDescription None = new ReceivedDescription();

        ReceivedDescription() { }

        public string Text { get; private set; }
        public RobotModel Model { get; private set; }
        public RobotDescriptionMatch Match { get; private set; }

        /// <param name="fault">What is wrong with the text, in one line; null when nothing is.</param>
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
